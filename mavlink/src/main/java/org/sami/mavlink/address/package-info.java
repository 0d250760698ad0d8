/**
 * Addresses of MAVLink links, as people write them.
 *
 * <p>Not here: sockets and ports, which {@code mavlink.link} opens.
 */
@NullMarked
package org.sami.mavlink.address;

import org.jspecify.annotations.NullMarked;
