package org.sami.spn.json;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * Which definitions count where a domain combines others. The domain's own files come first: what they define replaces what the combined domains call by
 * the same name. Two combined domains that define a name in the same way share the first one's definition; where they differ and the domain itself does
 * not say what holds, that is a finding that names both files.
 */
final class JoinedWords {
    private static final List<String> MEMBERS = List.of("types", "events", "markups", "taskClasses");
    private static final List<String> NAMES = List.of("name", "record", "enum");

    private final Problems problems;
    private final Set<String> replaced = new LinkedHashSet<>(); // by pointer

    JoinedWords(Problems problems) {
        this.problems = problems;
    }

    private record Definition(String file, String pointer, JsonNode node, boolean own) {}

    /**
     * Compares the definitions of all files.
     *
     * @param combines names of the domains whose files begin with {@code NAME/}
     * @param roots all files, the domain's own first
     */
    void join(List<String> combines, Map<String, JsonObjectReader> roots) {
        if (combines.isEmpty()) {
            return;
        }
        for (String member : MEMBERS) {
            Map<String, Definition> first = new LinkedHashMap<>();
            roots.forEach((file, root) -> {
                boolean own = combines.stream().noneMatch(domain -> file.startsWith(domain + "/"));
                JsonNode list = root.whole().path(member);
                for (int i = 0; list.isArray() && i < list.size(); i++) {
                    String pointer = Problems.at(root.at(member), i);
                    compare(member, name(list.get(i)), new Definition(file, pointer, list.get(i), own), first);
                }
            });
        }
    }

    private static String name(JsonNode definition) {
        return NAMES.stream()
                .map(member -> definition.path(member).asText(""))
                .filter(name -> !name.isEmpty())
                .findFirst()
                .orElse("");
    }

    private void compare(String member, String name, Definition next, Map<String, Definition> first) {
        Definition before = name.isEmpty() ? null : first.putIfAbsent(name, next);
        if (before == null || next.own()) { // the same name twice in the domain's own files is found by its reader
            return;
        }
        replaced.add(next.pointer());
        if (!before.own() && !before.node().equals(next.node())) {
            problems.add(
                    Codes.DUPLICATE,
                    next.pointer(),
                    "\"" + name + "\" is defined in " + before.file() + " and differently in " + next.file()
                            + ": define it under \"" + member + "\" in the files of the domain that combines both",
                    name);
        }
    }

    /** Whether another definition holds in place of the one at a pointer. */
    boolean isReplaced(String pointer) {
        return replaced.contains(pointer);
    }
}
