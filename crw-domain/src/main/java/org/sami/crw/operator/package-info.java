/**
 * What lies before the operator, as models that windows, consoles, the simulated operator and reports read: decisions, messages,
 * missions, boats and links, communication, command queues, interrupts, alarms, allocation, map, operator log, clicks
 * (docs/operator-models.md).
 *
 * <p>Belongs here: models and the immutable snapshots that they give out. Does not belong here: anything of Swing, when and how a
 * decision is answered ({@code org.sami.crw.decision}), what decisions mean to a plan ({@code spn.engine}).
 *
 * <p>{@link org.sami.crw.operator.OperatorModels} feeds all models, with one hop to their one owner's thread. Snapshots may be read from
 * any thread; no public method of a model waits for another thread (docs/threads.md).
 */
package org.sami.crw.operator;
