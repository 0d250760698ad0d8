package org.sami.spn.json;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;

/**
 * The plans of a project's document, each in the document itself or in a file of its own next to it.
 *
 * @param file the document's file; empty text where it came from none
 * @param sibling the files next to it
 * @param sources where the texts of the plans' files are kept for the places of findings
 */
record PlanFiles(String file, DomainSources.Source sibling, SourceTexts sources) {
    PlanFiles {
        Objects.requireNonNull(file, "file");
        Objects.requireNonNull(sibling, "sibling");
        Objects.requireNonNull(sources, "sources");
    }

    /** The plans' objects by pointer; those in files of their own have pointers that begin with the file's name. */
    Map<String, JsonObjectReader> plans(JsonObjectReader root, Problems problems) {
        Map<String, JsonObjectReader> plans = new LinkedHashMap<>();
        for (JsonObjectReader m : root.objects("plans")) {
            if (!m.has("file")) {
                plans.put(m.pointer(), m);
                continue;
            }
            String name = m.text("file");
            m.done();
            if (name.contains("..") || name.startsWith("/") || name.contains("\\") || name.contains(":")) {
                m.problem(Codes.FILE, "file", "A plan's file lies in the project's folder, not at " + name);
                continue;
            }
            Problems inFile = new Problems();
            VocabularyFiles.fetch(sibling, name, inFile)
                    .flatMap(text -> {
                        String prefix = name + "#";
                        sources.add(prefix, sibling(name), text);
                        sources.planIn(plans.size(), prefix);
                        Problems syntax = new Problems();
                        var node = JsonText.parse(text, syntax);
                        inFile.addAll(syntax.findings(), prefix);
                        return node;
                    })
                    .flatMap(node -> JsonObjectReader.of(node, name + "#", problems))
                    .ifPresent(members -> {
                        members.text(ProjectReader.SCHEMA, ""); // for editors, as in the project's document
                        plans.put(name, members);
                    });
            problems.addAll(inFile.findings(), "");
        }
        return plans;
    }

    private String sibling(String name) {
        return file.isEmpty() ? name : Path.of(file).resolveSibling(name).toString();
    }
}
