package org.sami.session.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The types of rows that the page is checked against are those of docs/session-link.md. */
class PageProtocolTest {
    private final String types = read("src/main/typescript/protocol.ts");
    private final String page = read("../docs/session-link.md");

    @Test
    void membersOfRowsStandInTheDescriptionOfTheirTableAndMayBeAbsentWhereItSaysSo() {
        List<String> wrong = new ArrayList<>();
        Map<String, String> tables = new LinkedHashMap<>();
        members("Tables").forEach((table, member) -> tables.put(table, member.type()));

        tables.forEach((table, type) -> {
            if (table.equals("decisions")) {
                compare(table, "AnyDecision", page.substring(page.indexOf("### Decisions")), wrong);
            } else {
                compare(table, type, rowOf(table), wrong);
            }
        });

        assertThat(tables).hasSizeGreaterThan(10);
        assertThat(wrong).isEmpty();
    }

    @Test
    void membersThatADescriptionNamesStandInTheRowsThatThePageKnows() {
        List<String> missing = new ArrayList<>();

        members("Tables").forEach((table, member) -> {
            boolean isDecision = table.equals("decisions");
            Set<String> known = isDecision
                    ? Stream.of("YesNoDecision", "BoatsDecision", "OptionDecision", "FieldsDecision")
                            .flatMap(form -> membersWithInherited(form).stream())
                            .collect(Collectors.toSet())
                    : membersWithInherited(member.type());
            Set<String> described = isDecision ? describedOfDecisions() : namedIn(rowOf(table));
            assertThat(described).as(table).contains("id");
            described.stream().filter(name -> !known.contains(name)).forEach(name -> missing.add(table + "." + name));
        });

        assertThat(missing).isEmpty();
    }

    @Test
    void membersAreThoseBeforeADescriptionExplainsThem() {
        assertThat(namedIn("`id`, `lat`° `lon`°, `stop`° (`here`, `elsewhere`), `pictures`: `[{\"name\"}]`, `state` is"
                        + " `coming` |"))
                .containsExactly("id", "lat", "lon", "stop", "pictures");
        assertThat(namedIn("`id`, `severity`. One row a fault of `kind` |")).containsExactly("id", "severity");
    }

    @Test
    void aMemberThatIsNotDescribedIsFound() {
        List<String> wrong = new ArrayList<>();

        compare("boats", "BoatRow", "`lat` `lon`°", wrong);

        assertThat(wrong)
                .contains("boats.lat: only one says that it may be absent", "boats.heading: not described")
                .doesNotContain("boats.lon: only one says that it may be absent");
    }

    private void compare(String table, String type, String described, List<String> wrong) {
        members(type).forEach((name, member) -> {
            Matcher there = Pattern.compile("[`\"]" + name + "[`\"](°?)").matcher(described);
            if (!there.find()) {
                wrong.add(table + "." + name + ": not described");
            } else if (member.mayBeAbsent() == there.group(1).isEmpty()) {
                wrong.add(table + "." + name + ": only one says that it may be absent");
            }
        });
    }

    /** The members that a row of the table of tables names: its words in code outside of parentheses, up to where it begins to explain. */
    private static Set<String> namedIn(String described) {
        Set<String> names = new LinkedHashSet<>();
        String plain = described.replaceAll("\\([^()]*\\)", "").replaceAll("\\([^()]*\\)", "");
        Matcher each = Pattern.compile("`(\\w+)`|(: |\\. )").matcher(plain);
        while (each.find() && each.group(2) == null) {
            names.add(each.group(1));
        }
        return names;
    }

    /** Those in the first cells of the table of a decision's members. */
    private Set<String> describedOfDecisions() {
        String section = page.substring(page.indexOf("### Decisions"), page.indexOf("Types of fields"));
        Set<String> names = new LinkedHashSet<>();
        Matcher row = Pattern.compile("(?m)^\\| (`[^|]*) \\|").matcher(section);
        while (row.find()) {
            names.addAll(namedIn(row.group(1)));
        }
        return names;
    }

    private Set<String> membersWithInherited(String type) {
        Set<String> names = new LinkedHashSet<>(members(type).keySet());
        Matcher head = Pattern.compile("interface " + type + " extends (\\w+)").matcher(types);
        if (head.find()) {
            names.addAll(membersWithInherited(head.group(1)));
        }
        return names;
    }

    private record Member(String type, boolean mayBeAbsent) {}

    /** Those that an interface names itself. */
    private Map<String, Member> members(String type) {
        Matcher whole = Pattern.compile("interface " + type + " [^{]*\\{\\n(.*?)\\n}", Pattern.DOTALL)
                .matcher(types);
        assertThat(whole.find()).as(type).isTrue();
        Map<String, Member> members = new LinkedHashMap<>();
        Matcher each = Pattern.compile("(?m)^  (\\w+)(\\??): (.*);$").matcher(whole.group(1));
        while (each.find()) {
            members.put(each.group(1), new Member(each.group(3), !each.group(2).isEmpty()));
        }
        return members;
    }

    private String rowOf(String table) {
        Matcher row = Pattern.compile("(?m)^\\| `" + table + "` \\| (.*)$").matcher(page);
        assertThat(row.find()).as(table).isTrue();
        return row.group(1);
    }

    private static String read(String path) {
        try {
            return Files.readString(Path.of(path));
        } catch (IOException fault) {
            throw new UncheckedIOException(fault);
        }
    }
}
