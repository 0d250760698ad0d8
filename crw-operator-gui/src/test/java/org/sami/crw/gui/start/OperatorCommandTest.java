package org.sami.crw.gui.start;

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
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.palette.Theme;
import picocli.CommandLine;

class OperatorCommandTest {
    @TempDir
    private Path folder;

    private final StringWriter err = new StringWriter();
    private final List<StartOptions> opened = new ArrayList<>();

    @Test
    void boatsComeFromTheCommandLineAndFromAFile() throws IOException {
        Path file = folder.resolve("boats.txt");
        Files.writeString(file, "127.0.0.1:11412 # the second\n\n# none\n127.0.0.1:11413\n");

        assertThat(run("--connect", "127.0.0.1:11411", "--boats", file.toString()))
                .as(err.toString())
                .isZero();

        assertThat(opened.get(0).boats())
                .containsExactly(
                        BoatAddress.parse("127.0.0.1:11411"),
                        BoatAddress.parse("127.0.0.1:11412"),
                        BoatAddress.parse("127.0.0.1:11413"));
    }

    @Test
    void lookIsTakenOver() {
        assertThat(run("--theme", "sun", "--scale", "150")).as(err.toString()).isZero();

        assertThat(opened.get(0).theme()).contains(Theme.SUN);
        assertThat(opened.get(0).scale()).contains(150);
    }

    @Test
    void badInputIsAnsweredInOneLine() throws IOException {
        Path file = folder.resolve("boats.txt");
        Files.writeString(file, "127.0.0.1:11411\nboat\n");

        assertRefused(2, "there is no theme pink", "--theme", "pink");
        assertRefused(2, "--scale: 20 is not from 80 to 200 percent", "--scale", "20");
        assertRefused(2, "boat", "--connect", "boat");
        assertRefused(2, "--open and --keys contradict each other", "--open", "--keys", "keys");
        assertRefused(2, "boats.txt is a file: the keys of a base are a folder", "--keys", file.toString());
        assertRefused(
                4, "no-boats.txt", "--boats", folder.resolve("no-boats.txt").toString());
        assertThat(opened).isEmpty();
    }

    private void assertRefused(int code, String why, String... args) {
        err.getBuffer().setLength(0);
        assertThat(run(args)).as(err.toString()).isEqualTo(code);
        assertThat(err.toString()).startsWith("crw-operator: ").contains(why);
        assertThat(err.toString().strip().lines()).hasSize(1);
    }

    private int run(String... args) {
        List<String> all = new ArrayList<>(List.of(args));
        all.addAll(List.of("--data", folder.resolve("data").toString()));
        return new CommandLine(new OperatorCommand((options, data) -> {
                    opened.add(options);
                    data.close();
                }))
                .setErr(new PrintWriter(err, true))
                .execute(all.toArray(String[]::new));
    }
}
