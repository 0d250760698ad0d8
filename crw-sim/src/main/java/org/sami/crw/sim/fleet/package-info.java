/**
 * A whole simulated fleet in one process: hulls, boat servers, pipes and the base's proxies on one virtual clock.
 */
@NullMarked
package org.sami.crw.sim.fleet;

import org.jspecify.annotations.NullMarked;
