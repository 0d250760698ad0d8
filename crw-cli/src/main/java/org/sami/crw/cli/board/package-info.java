/**
 * Real boats and control boards on the command line: {@code crw boat --board} and {@code crw board}, and the ports of this machine.
 *
 * <p>Not here: simulated boats ({@link org.sami.crw.cli.run}), what is said to a board ({@code org.sami.boat.hull}).
 */
@NullMarked
package org.sami.crw.cli.board;

import org.jspecify.annotations.NullMarked;
