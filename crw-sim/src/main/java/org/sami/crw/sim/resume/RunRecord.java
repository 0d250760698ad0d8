package org.sami.crw.sim.resume;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import org.sami.crw.sim.run.RunSettings;
import org.sami.spn.journal.JournalHeader;

/**
 * What the header of a run's journal says: all that the run is a function of.
 *
 * @param source where the project came from: a file's path, or the name of a plan of the library
 * @param project the project as one document
 * @param vocabulary the domain's files by name
 */
public record RunRecord(RunSettings settings, String source, String project, Map<String, String> vocabulary) {
    private static final String KIND = "kind";
    private static final String IN_PROCESS = "in-process";
    private static final String TCP = "tcp";
    private static final String SOURCE = "source";

    public RunRecord {
        Objects.requireNonNull(settings, "settings");
        Objects.requireNonNull(source, "source");
        Objects.requireNonNull(project, "project");
        vocabulary = Collections.unmodifiableMap(new LinkedHashMap<>(vocabulary));
    }

    /** The header of a run's journal. */
    public JournalHeader toHeader() {
        Map<String, String> map = new TreeMap<>(settings.toMap());
        map.put(KIND, settings.isConnected() ? TCP : IN_PROCESS);
        map.put(SOURCE, source);
        return JournalHeader.of(project, vocabulary, map);
    }

    /**
     * Reads a header.
     *
     * @throws IllegalArgumentException if it is not that of a run
     */
    public static RunRecord of(JournalHeader header) {
        Map<String, String> map = header.settings();
        if (!IN_PROCESS.equals(map.get(KIND)) && !TCP.equals(map.get(KIND))) {
            throw new IllegalArgumentException("it is not the journal of a run");
        }
        return new RunRecord(
                RunSettings.fromMap(map), map.getOrDefault(SOURCE, ""), header.project(), header.vocabulary());
    }
}
