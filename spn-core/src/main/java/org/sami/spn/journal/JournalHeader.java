package org.sami.spn.journal;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.sami.spn.engine.RuleVersion;

/**
 * What a journal says before its first entry: all that a resume needs besides the entries. Written once.
 *
 * @param formatVersion of the journal's file
 * @param project the project's document as it ran
 * @param vocabulary the domain's documents as they ran, by file name, in the order in which they are read
 * @param settings free: settings of the run, its seed, who made it and when (a journal reads no clock)
 */
public record JournalHeader(
        int formatVersion, String project, Map<String, String> vocabulary, Map<String, String> settings) {
    /** The version that this program writes. */
    public static final int CURRENT_VERSION = 1;

    public JournalHeader {
        Objects.requireNonNull(project, "project");
        vocabulary = Collections.unmodifiableMap(new LinkedHashMap<>(vocabulary));
        settings = Collections.unmodifiableMap(new LinkedHashMap<>(settings));
    }

    /** A header of the current version of the file, and of this program's rules unless the settings name others ({@link RuleVersion}). */
    public static JournalHeader of(String project, Map<String, String> vocabulary, Map<String, String> settings) {
        Map<String, String> all = new LinkedHashMap<>(settings);
        all.putIfAbsent(RuleVersion.SETTING, Integer.toString(RuleVersion.CURRENT));
        return new JournalHeader(CURRENT_VERSION, project, vocabulary, all);
    }

    /**
     * Which documents differ now from those that ran: the journal's own are used, and the user is notified.
     *
     * @param projectName how the project's file is called in the answer
     * @return names of documents that changed, came or went; empty where all is as it was
     */
    public List<String> differences(String projectName, String currentProject, Map<String, String> currentVocabulary) {
        List<String> names = new ArrayList<>();
        if (!project.equals(currentProject)) {
            names.add(projectName);
        }
        vocabulary.forEach((name, text) -> {
            if (!text.equals(currentVocabulary.get(name))) {
                names.add(name);
            }
        });
        currentVocabulary.keySet().stream()
                .filter(name -> !vocabulary.containsKey(name))
                .forEach(names::add);
        return names;
    }
}
