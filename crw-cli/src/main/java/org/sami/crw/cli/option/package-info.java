/**
 * Options and arguments that several subcommands have, what they allow, and how their texts are read.
 *
 * <p>Does not belong here: options of one subcommand (they stand in its class), what comes of them.
 */
@NullMarked
package org.sami.crw.cli.option;

import org.jspecify.annotations.NullMarked;
