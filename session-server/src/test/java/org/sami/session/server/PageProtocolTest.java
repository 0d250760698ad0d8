package org.sami.session.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
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
