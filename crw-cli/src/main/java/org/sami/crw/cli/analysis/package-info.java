/**
 * The command that analyses Petri nets of files, and its words.
 *
 * <p>Not here: checks of plans, which {@code crw check} makes, and the analysis itself, which the module {@code petri} has.
 */
@NullMarked
package org.sami.crw.cli.analysis;

import org.jspecify.annotations.NullMarked;
