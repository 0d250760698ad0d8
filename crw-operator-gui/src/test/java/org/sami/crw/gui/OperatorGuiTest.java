package org.sami.crw.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.spn.testing.JavaProcess;

/** The program in a process of its own, without a display. */
class OperatorGuiTest {
    @TempDir
    private Path folder;

    @Test
    void withoutADisplayItSaysSoAndTheDemonstrationIsTold() throws Exception {
        Process program = start();
        try {
            String said = "";
            for (String line;
                    (line = program.errorReader(StandardCharsets.UTF_8).readLine()) != null; ) {
                said += line + "\n";
                if (line.contains("is process")) {
                    break;
                }
            }
            assertThat(said).startsWith("crw-operator: there is no display").contains("anna is process");
        } finally {
            program.descendants().forEach(ProcessHandle::destroy);
            program.destroy();
            program.waitFor(60, TimeUnit.SECONDS);
        }
    }

    @Test
    void aCommandOfCrwIsThatCommand() throws Exception {
        Process program = start("plans");

        String said = new String(program.getInputStream().readAllBytes(), StandardCharsets.UTF_8);

        assertThat(program.waitFor()).isZero();
        assertThat(said).contains("clv");
    }

    private Process start(String... arguments) throws Exception {
        ProcessBuilder builder =
                JavaProcess.builder(folder, OperatorGui.class, arguments).directory(folder.toFile());
        builder.environment().remove("DISPLAY");
        builder.environment().remove("JAVA_TOOL_OPTIONS");
        return builder.start();
    }
}
