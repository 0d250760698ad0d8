/**
 * Subcommands about plans and the words that they use: list, make, check, test, draw; events, markups, components, schemas, phases.
 *
 * <p>Nothing here runs a mission on boats ({@code run}).
 */
@NullMarked
package org.sami.crw.cli.plan;

import org.jspecify.annotations.NullMarked;
