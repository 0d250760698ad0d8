/**
 * What is to be said of an operator's answer while it is given: what of an area is left out, which places boats are not to enter, which values cannot be, and
 * what the work costs in length, time and charge.
 *
 * <p>{@link org.sami.crw.judgement.AnswerJudge} judges a draft by values alone, on any thread; {@link org.sami.crw.session.Session#judge} hands it what it
 * needs. Does not belong here: whether an answer has the form that its question asks for ({@code org.sami.spn.engine.DecisionCheck}), what the operator is asked
 * once boats are sent ({@code org.sami.crw.handler.motion}).
 */
package org.sami.crw.judgement;
