/**
 * The parameters of vehicles: read whole, kept by vehicle in files, set one by one and read back.
 *
 * <p>Not here: what parameters mean, which whoever compares them knows.
 */
@NullMarked
package org.sami.mavlink.param;

import org.jspecify.annotations.NullMarked;
