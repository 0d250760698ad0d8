/**
 * Who has which tasks to do, in which order, and the news of it for plans. Which boat a task is allocated to is the engine's; how
 * tasks are divided is decided in {@code org.sami.crw.service.allocation}; what the events of tasks do is in
 * {@code org.sami.crw.handler}.
 */
@NullMarked
package org.sami.crw.task;

import org.jspecify.annotations.NullMarked;
