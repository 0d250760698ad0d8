/**
 * Simulated links: frames travel between a proxy and a boat server in virtual time, without sockets and, by default, without the codec.
 */
@NullMarked
package org.sami.crw.sim.link;

import org.jspecify.annotations.NullMarked;
