/**
 * The inspector: editors of what is selected in the net – vertices, events with their fields and markup (thesis, Figure 5.3), edges with their
 * requirements, sub-missions – and of the plan where nothing is selected. Every change is an edit. It knows events, markups, tasks and types
 * of values from the vocabulary alone.
 */
@NullMarked
package org.sami.dreamm.inspector;

import org.jspecify.annotations.NullMarked;
