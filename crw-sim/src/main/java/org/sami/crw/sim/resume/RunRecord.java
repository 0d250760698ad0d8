package org.sami.crw.sim.resume;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.time.ZoneId;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.crw.sim.run.settings.SettingsMap;
import org.sami.spn.journal.JournalHeader;

/**
 * What the header of a run's journal says: all that the run is a function of.
 *
 * @param source where the project came from: a file's path, or the name of a plan of the library
 * @param project the project as one document
 * @param vocabulary the domain's files by name
 * @param start when and where it began, which nothing in it depends on; empty in journals that do not say so
 * @param answersFile where the text of the answers in the settings was read; empty where there was none, and in journals that do not say so
 * @param domainFolder the folder of the domain; empty for one that comes with the program, and in journals that do not say so
 */
public record RunRecord(
        RunSettings settings,
        String source,
        String project,
        Map<String, String> vocabulary,
        Optional<Start> start,
        Optional<Path> answersFile,
        Optional<Path> domainFolder) {
    private static final String KIND = "kind";
    private static final String IN_PROCESS = "in-process";
    private static final String TCP = "tcp";
    private static final String DRIVING = "driving";

    /**
     * How simulated boats drive: 1, which headers do not name, straight to the next waypoint; 2 along the lines between them
     * (docs/decisions, 0300); 3 giving way to one another as well (0320); 4 on ways that are allocated otherwise (docs/services.md); 5 outside no-go
     * areas meanwhile; 6 stopping at once (0300); 7 reading messages at the start of a tick (0316); 10 turning
     * off slowly near no-go areas, in the middle of narrow gaps, with more lanes in jagged areas (docs/services.md). A run
     * of another version cannot be run again.
     */
    private static final String PRESENT_DRIVING = "10";

    /** The same of runs with copters: 10 flying off before they are up, and never asked about for their charge. */
    private static final String PRESENT_FLYING = "11";

    private static final String SOURCE = "source";
    private static final String ANSWERS_FILE = "answersFile";
    private static final String DOMAIN_FOLDER = "domainFolder";
    private static final String STARTED_AT = "startedAt";
    private static final String TIME_ZONE = "timeZone";

    /** When a run began, and the time zone of the machine on which it did. */
    public record Start(Instant at, ZoneId zone) {
        public Start {
            Objects.requireNonNull(at, "at");
            Objects.requireNonNull(zone, "zone");
        }
    }

    public RunRecord {
        Objects.requireNonNull(settings, "settings");
        Objects.requireNonNull(source, "source");
        Objects.requireNonNull(project, "project");
        Objects.requireNonNull(start, "start");
        Objects.requireNonNull(answersFile, "answersFile");
        Objects.requireNonNull(domainFolder, "domainFolder");
        vocabulary = Collections.unmodifiableMap(new LinkedHashMap<>(vocabulary));
    }

    /** A record that does not say when the run began. */
    public RunRecord(RunSettings settings, String source, String project, Map<String, String> vocabulary) {
        this(settings, source, project, vocabulary, Optional.empty(), Optional.empty(), Optional.empty());
    }

    /** The same run with other settings. */
    public RunRecord with(RunSettings others) {
        return new RunRecord(others, source, project, vocabulary, start, answersFile, domainFolder);
    }

    /** The header of a run's journal. */
    public JournalHeader toHeader() {
        Map<String, String> map = new TreeMap<>(SettingsMap.write(settings));
        map.put(KIND, settings.isConnected() ? TCP : IN_PROCESS);
        map.put(SOURCE, source);
        if (!settings.isConnected()) {
            map.put(DRIVING, present(map));
        }
        start.ifPresent(begun -> {
            map.put(STARTED_AT, begun.at().toString());
            map.put(TIME_ZONE, begun.zone().getId());
        });
        answersFile.ifPresent(file -> map.put(ANSWERS_FILE, file.toString()));
        domainFolder.ifPresent(folder -> map.put(DOMAIN_FOLDER, folder.toString()));
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
                SettingsMap.read(map),
                map.getOrDefault(SOURCE, ""),
                header.project(),
                header.vocabulary(),
                start(map),
                Optional.ofNullable(map.get(ANSWERS_FILE)).map(Path::of),
                Optional.ofNullable(map.get(DOMAIN_FOLDER)).map(Path::of));
    }

    /** Says of the answers file that it differs now from what the run began with; empty where it does not, or none was named. */
    public Optional<String> otherAnswers() {
        if (answersFile.isEmpty()) {
            return Optional.empty();
        }
        try {
            return Files.readString(answersFile.get()).equals(settings.answers())
                    ? Optional.empty()
                    : Optional.of(answersFile.get().toString());
        } catch (IOException gone) {
            return Optional.of(answersFile.get() + ", which cannot be read any longer,");
        }
    }

    private static String present(Map<String, String> settings) {
        return SettingsMap.hasCopters(settings) ? PRESENT_FLYING : PRESENT_DRIVING;
    }

    /** Why the run of a header cannot be gone through again; empty where it can. */
    static Optional<String> otherDriving(JournalHeader header) {
        String driving = header.settings().getOrDefault(DRIVING, "1");
        String present = present(header.settings());
        return IN_PROCESS.equals(header.settings().get(KIND)) && !driving.equals(present)
                ? Optional.of("it is of a program whose simulated boats drove otherwise (version " + driving
                        + " of driving, this one's is " + present
                        + "), so the run cannot be gone on with; crw journal and crw export read it")
                : Optional.empty();
    }

    private static Optional<Start> start(Map<String, String> map) {
        return Optional.ofNullable(map.get(STARTED_AT))
                .map(at -> new Start(Instant.parse(at), ZoneId.of(map.getOrDefault(TIME_ZONE, "UTC"))));
    }
}
