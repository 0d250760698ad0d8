package org.sami.dreamm.start;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

class DreammCommandTest {
    @TempDir
    private Path folder;

    private final StringWriter err = new StringWriter();
    private final List<FirstProject> opened = new ArrayList<>();

    @Test
    void withoutArgumentsTheLibraryIsOpened() {
        assertThat(run()).isZero();

        assertThat(opened.get(0).document().project().plans()).hasSizeGreaterThan(10);
        assertThat(opened.get(0).document().file()).isEmpty();
    }

    @Test
    void aPlanOfTheLibraryIsOpenedByItsId() {
        assertThat(run("station-keep")).isZero();

        assertThat(opened.get(0).plan()).contains("station-keep");
    }

    @Test
    void aFolderOfAnotherDomainGivesItsWords() throws IOException {
        Files.writeString(folder.resolve("domain.json"), """
                {"formatVersion": 1, "domain": "rover", "label": "Rovers", "files": ["events.json"], "library": []}
                """);
        Files.writeString(folder.resolve("events.json"), """
                {"events": [
                  {"name": "Drive", "direction": "output", "label": "Drive", "help": "Drives on.", "tokens": "proxy",
                   "answers": ["Driven"]},
                  {"name": "Driven", "direction": "input", "label": "Driven", "help": "It has driven.", "tokens": "proxy"}]}
                """);
        assertThat(run("--domain", folder.toString())).as(err.toString()).isZero();

        assertThat(opened.get(0).document().vocabulary().domain()).isEqualTo("rover");
    }

    @Test
    void domainsThatShipAreOpenedByTheNamesThatTheHelpSays() {
        assertThat(run("--domain", "team", "scout-and-sample"))
                .as(err.toString())
                .isZero();

        assertThat(opened.get(0).plan()).contains("scout-and-sample");
        String help = new CommandLine(new DreammCommand((options, first, data) -> {})).getUsageMessage();
        assertThat(help).contains("--domain=NAME|FOLDER").containsPattern("uav or team,\\s+which ship");
    }

    @Test
    void badInputIsAnsweredInOneLine() throws IOException {
        Files.writeString(folder.resolve("p.json"), "[]");

        assertRefused(4, "no file, folder or plan of the library nowhere.json", "nowhere.json");
        assertRefused(4, "is not opened", folder.resolve("p.json").toString());
        assertRefused(
                4, "there is no profile", "--profile", folder.resolve("q.json").toString());
        assertRefused(
                4,
                "the domain " + folder.resolve("d"),
                "--domain",
                folder.resolve("d").toString());
        assertRefused(4, "--data", "--data", folder.resolve("p.json/data").toString());
        assertRefused(2, "there is no theme pink", "--theme", "pink");
        assertRefused(2, "--scale: 300 is not from 80 to 200 percent", "--scale", "300");
    }

    private void assertRefused(int code, String why, String... args) {
        err.getBuffer().setLength(0);
        assertThat(run(args)).as(err.toString()).isEqualTo(code);
        assertThat(err.toString()).startsWith("dreamm: ").contains(why);
        assertThat(err.toString().strip().lines()).hasSize(1);
    }

    private int run(String... args) {
        List<String> all = new ArrayList<>(List.of(args));
        if (!all.contains("--data")) {
            all.addAll(List.of("--data", folder.resolve("data").toString()));
        }
        return new CommandLine(new DreammCommand((options, first, data) -> opened.add(first)))
                .setErr(new PrintWriter(err, true))
                .execute(all.toArray(String[]::new));
    }
}
