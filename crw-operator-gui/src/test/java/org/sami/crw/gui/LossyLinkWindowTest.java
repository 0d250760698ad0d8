package org.sami.crw.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.session.client.testing.TwoNetworks;
import org.sami.spn.testing.JavaProcess;
import org.sami.ui.check.RealDisplay;

/** The operator's window of a session elsewhere over a network that loses one packet in five each way: real processes, in networks of their own. */
@Tag("window")
class LossyLinkWindowTest {
    private static final double LOST = 0.2;
    private static final double STARTS_WITHIN_S = 300;
    private static final int ENDS_WITHIN_S = 1200;

    @TempDir
    private Path folder;

    @Test
    void operatorAnswersAndStopsTheFleet() throws Exception {
        RealDisplay.assumed();
        File base = folder.resolve("base.out").toFile();
        File window = folder.resolve("window.out").toFile();
        try (TwoNetworks networks = new TwoNetworks()) {
            networks.lose(LOST);
            Process serving =
                    started(networks.inFirst(), LossyBase.class, base, folder.toString(), TwoNetworks.FIRST_ADDRESS);
            try {
                Await.until("it serves", STARTS_WITHIN_S, () -> text(base).contains("\n") || !serving.isAlive());
                assertThat(text(base)).startsWith("wss://");
                String[] served = text(base).strip().split(" ");
                String data = Files.createDirectories(folder.resolve("window")).toString();
                Process operator = started(networks.inSecond(), LossyWindow.class, window, served[0], served[1], data);
                try {
                    assertThat(operator.waitFor(ENDS_WITHIN_S, TimeUnit.SECONDS))
                            .as(text(window))
                            .isTrue();
                } finally {
                    operator.destroyForcibly().waitFor();
                }

                assertThat(text(window)).contains("answered ").contains("stopped ");
                assertThat(operator.exitValue()).as(text(window)).isZero();
                Await.until(
                        "the base has both",
                        () -> text(base).contains("answered") && text(base).contains("stopped"));
            } finally {
                serving.destroyForcibly().waitFor();
            }
        }
    }

    private Process started(List<String> network, Class<?> main, File out, String... arguments) throws Exception {
        ProcessBuilder builder = JavaProcess.builder(folder, main, arguments);
        List<String> line = new ArrayList<>(network);
        line.addAll(builder.command());
        return builder.command(line)
                .redirectError(ProcessBuilder.Redirect.INHERIT)
                .redirectOutput(out)
                .start();
    }

    private static String text(File file) {
        try {
            return Files.readString(file.toPath(), StandardCharsets.UTF_8);
        } catch (IOException unreadable) {
            throw new UncheckedIOException(unreadable);
        }
    }
}
