# What ./run and ./test share; sourced by both with the repository as working directory.

# A python of the user's own (pyenv, conda) does not see ROS's modules.
export PATH="/usr/bin:$PATH"

if [ -e /opt/ros/noetic/setup.bash ]; then  # Ubuntu 20.04; Debian's own ROS needs no setup
  set +u
  . /opt/ros/noetic/setup.bash
  set -u
fi

# Nodes tell each other this computer's name. One without an address (a container, a computer that was renamed) keeps
# every node from starting.
if [ -z "${ROS_HOSTNAME:-}${ROS_IP:-}" ] && ! getent hosts "$(hostname)" >/dev/null; then
  echo "$(basename -- "$0"): this computer's name, $(hostname), has no address (see /etc/hosts): ROS_HOSTNAME=localhost" \
    "instead; set ROS_IP where robots have computers of their own" >&2
  export ROS_HOSTNAME=localhost
fi

die() {
  echo "$(basename "$0"): $*" >&2
  exit 2
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then "$@"; else sudo "$@"; fi
}

# Installs what packages.apt lists and the machine lacks: install_packages run|test
install_packages() {
  if [ -e /opt/ros/noetic/setup.bash ]; then
    rosdep install --from-paths src --ignore-src -y || die "rosdep could not install the dependencies"
    return
  fi
  local wanted missing
  wanted=$(cat packages.apt)
  [ "$1" = test ] || wanted=$(sed '/^# testing$/,$d' packages.apt)
  missing=$(sed 's/#.*//' <<<"$wanted" | xargs -n1 |
    while read -r package; do
      dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || echo "$package"
    done)
  [ -n "$missing" ] || return 0
  echo "installing: $(echo $missing)"
  as_root apt-get update -q >/dev/null || die "apt-get update failed"
  # shellcheck disable=SC2086 # one word a package
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends \
    -o Dpkg::Use-Pty=0 $missing >/dev/null || die "apt-get install failed; missing: $(echo $missing)"
}

# catkin_make with what all builds of the suite have in common.
build() {
  # Tests run in an environment that catkin stores when it configures, with folders that exist then.
  mkdir -p devel/lib/python3/dist-packages
  local launcher=()
  if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
  catkin_make -DPYTHON_EXECUTABLE=/usr/bin/python3 -DCMAKE_EXPORT_COMPILE_COMMANDS=ON "${launcher[@]}" "$@"
}
