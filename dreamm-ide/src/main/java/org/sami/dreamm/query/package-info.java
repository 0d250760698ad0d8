/**
 * The queries of the plan that is written: kept with it, answered by a search of its net off the event thread, their runs shown on the net or played. What a query means
 * stands in {@code org.sami.spn.planspace}; trying the plan itself is in {@code org.sami.dreamm.tryout}.
 */
@NullMarked
package org.sami.dreamm.query;

import org.jspecify.annotations.NullMarked;
