/**
 * The mission tree (thesis 5.1): plans, their sub-missions and variables; names that are changed everywhere; where something is used, and the search
 * over everything.
 */
@NullMarked
package org.sami.dreamm.tree;

import org.jspecify.annotations.NullMarked;
