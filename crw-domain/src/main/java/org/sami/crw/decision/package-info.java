/**
 * The operator's side without a window: decisions that wait, messages, clicks, and an operator that is simulated.
 *
 * <p>Belongs here: models that windows, the simulated operator and tests share; how a decision is answered. Does not belong
 * here: anything of Swing, when an answer is given (the host's clock decides), what decisions mean to a plan
 * ({@code spn.engine}).
 *
 * <p>Models are owned by one thread: the event thread of a window, or the one thread of a headless run. {@link
 * org.sami.crw.decision.OperatorModels} is where they are fed, with one hop.
 */
package org.sami.crw.decision;
