package org.sami.crw.sim.resume;

import java.util.List;
import java.util.Map;
import java.util.OptionalLong;

/** What a journal that is taken up says of the run so far, of whichever kind the run is. */
public interface EarlierProcesses {
    /** What is run. */
    RunRecord record();

    /** Names of documents that are not now as they were when the run began. */
    List<String> differences(String project, Map<String, String> vocabulary);

    /** What was wrong with the file, in a sentence; empty text where nothing was. */
    String damage();

    /** Index of the last entry that an earlier process wrote; empty for a run from its start. */
    OptionalLong resumedFrom();

    /** The run's time to which earlier processes came, in milliseconds, as far as the journal knows. */
    long cameToMillis();
}
