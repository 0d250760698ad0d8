/**
 * The operator's models, which windows, consoles, the simulated operator and reports read: decisions, messages, missions, boats and
 * links, communication, command queues, interrupts, alarms, allocation, map, operator log, clicks (docs/operator-models.md).
 *
 * <p>Belongs here: the models, and what feeds them. {@link org.sami.crw.operator.OperatorModels} puts them together; {@code EngineFeed},
 * {@code FleetFeed} and {@link org.sami.crw.operator.ReplayFeed} feed them, with one hop to the one thread that owns them.
 * The values of their snapshots, and the computations on them, stand in a package for each subject: {@code message} (decisions and
 * messages), {@code mission}, {@code boat}, {@code alarm}, {@code area}, {@code map}. Does not belong here: anything of Swing, when and
 * how a decision is answered ({@code org.sami.crw.decision}), what decisions mean to a plan ({@code org.sami.spn.engine}).
 *
 * <p>Snapshots may be read from any thread; no public method of a model waits for another thread (docs/threads.md).
 */
@NullMarked
package org.sami.crw.operator;

import org.jspecify.annotations.NullMarked;
