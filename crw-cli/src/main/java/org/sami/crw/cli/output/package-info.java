/**
 * What subcommands print and how they end: findings, faults, progress, the log, exit codes, and what Ctrl-C does.
 *
 * <p>Does not belong here: texts of one subcommand's subject (phases, components, states), which are in its package.
 */
@NullMarked
package org.sami.crw.cli.output;

import org.jspecify.annotations.NullMarked;
