package org.sami.house

import org.gradle.api.services.BuildService
import org.gradle.api.services.BuildServiceParameters

/**
 * Knows the result folders of the test tasks that this build came to, up to date or run. A folder of a task that was not reached, as its module failed to
 * compile, holds the results of an earlier build.
 */
abstract class TestRecord implements BuildService<BuildServiceParameters.None> {
    private final Set<File> folders = new TreeSet<>()

    /** Enters the folder of a task that is about to run or to be found up to date; true, so that it serves as the task's condition. */
    synchronized boolean enter(File folder) {
        folders << folder
        return true
    }

    synchronized TestCount count() {
        def count = new TestCount()
        folders.each { count.addFolder(it) }
        return count
    }
}
