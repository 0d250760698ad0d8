/** What a learner sees of a lesson: thin views of the models of {@link org.sami.dreamm.learn}. On the event thread. */
@NullMarked
package org.sami.dreamm.learn.view;

import org.jspecify.annotations.NullMarked;
