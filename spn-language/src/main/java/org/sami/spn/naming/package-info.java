/**
 * What people call the parts of a plan.
 *
 * <p>Belongs here: the one name that a vertex, an edge or an event has in all sentences: drawings, findings, runs that are
 * tried, the command. Does not belong here: what is written at a vertex on a drawing ({@code spn.drawing}), titles of event types ({@code
 * spn.vocabulary}).
 */
@NullMarked
package org.sami.spn.naming;

import org.jspecify.annotations.NullMarked;
