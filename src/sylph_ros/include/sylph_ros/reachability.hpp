#pragma once

#include <string>
#include <vector>

/// The pitfall of ROS on several computers: the master tells where a node is by the name or address
/// that the node gave itself, which need not mean anything here. Topics are then listed, but
/// nothing ever comes on them. http://wiki.ros.org/ROS/NetworkSetup
namespace sylph_ros {

/// Whether nodes can be connected to at the addresses that they have registered,
/// `http://<host>:<port>/`. Takes up to `timeout_s` for each that does not answer, and as long as
/// the system takes to look up a name.
/// @return per node that cannot be reached one line for the operator, with what helps; empty for
/// the others
std::string whyUnreachable(const std::string& node, const std::string& uri, double timeout_s);

/// whyUnreachable() of all nodes that publish a topic below a namespace, as the master knows them.
/// @param ns  absolute, such as "/lab" or "/"
/// @return one line per node, by name; none if the master does not answer
std::vector<std::string> unreachablePublishers(const std::string& ns, double timeout_s);

/// Robots whose nodes run in another namespace than the fleet's, as the master knows them: the
/// usual cause is a ROS_NAMESPACE that is set on one computer only.
/// @param ns  of the fleet, absolute, such as "/lab" or "/"
/// @return one line per robot, in their order; none if the master does not answer
std::vector<std::string> robotsElsewhere(const std::string& ns,
                                         const std::vector<std::string>& robots);

}  // namespace sylph_ros
