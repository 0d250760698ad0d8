package org.sami.crw.task;

import java.util.List;
import org.sami.spn.value.TaskId;

/** Gets to know what happens to tasks. What it throws is logged, and plans hear of the news all the same. */
@FunctionalInterface
public interface TaskListener {
    /**
     * Called on the engine's thread, before plans hear of it.
     *
     * @param names the task by the names that running missions have for it
     */
    void onNews(TaskNews news, List<TaskId> names);
}
