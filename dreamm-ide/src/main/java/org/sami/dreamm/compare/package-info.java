/**
 * Two versions of a plan: what differs, in words and on the net. {@link org.sami.dreamm.compare.PlanComparison} knows no window.
 */
@NullMarked
package org.sami.dreamm.compare;

import org.jspecify.annotations.NullMarked;
