/**
 * The sheet in which the operator says where simulated boats are shown to ground stations of other makers.
 *
 * <p>Not here: what is shown where, which is in {@code crw.cli.station}.
 */
@NullMarked
package org.sami.crw.gui.station;

import org.jspecify.annotations.NullMarked;
