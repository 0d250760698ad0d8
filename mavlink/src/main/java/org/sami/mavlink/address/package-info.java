/**
 * Addresses of MAVLink links, as people write them.
 *
 * <p>Not here: sockets and ports, which {@code mavlink.link} opens.
 */
package org.sami.mavlink.address;
