/** What waits for an answer in the decision queue, and how listeners learn of it. Not here: how a question is worded ({@code org.sami.crw.decision}). */
@NullMarked
package org.sami.crw.operator.decision;

import org.jspecify.annotations.NullMarked;
