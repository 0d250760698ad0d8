/**
 * Judgement of an operator's answer while it is given: parts of an area that are left out, places that boats may not enter, impossible values, and
 * the cost of the work in length, time and charge.
 *
 * <p>{@link org.sami.crw.judgement.AnswerJudge} judges a draft from values alone, on any thread; {@link org.sami.crw.session.JudgedAnswers} supplies
 * them. Not here: the form of an answer ({@code org.sami.spn.engine.DecisionCheck}), and questions to the operator before boats go ({@code
 * org.sami.crw.handler.motion}).
 */
@NullMarked
package org.sami.crw.judgement;

import org.jspecify.annotations.NullMarked;
