/**
 * The operator's console: a session that is run by typed commands, at a terminal or from a script (docs/console.md).
 *
 * <p>Belongs here: the commands, their completion, and the console's news. Does not belong here: what a session does
 * ({@code org.sami.crw.session}), and the options of {@code crw session}.
 */
@NullMarked
package org.sami.crw.console;

import org.jspecify.annotations.NullMarked;
