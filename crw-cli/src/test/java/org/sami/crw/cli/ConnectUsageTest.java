package org.sami.crw.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.crw.cli.output.ExitCode;

/** What is said of {@code --connect} before any boat has answered. */
class ConnectUsageTest {
    @TempDir
    Path folder;

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "--connect nowhere | 'nowhere' is no HOST:PORT",
                "--connect localhost:5001,localhost:5001 | localhost:5001 stands there twice",
                "--connect localhost:5001, | '' is no HOST:PORT",
                "--connect localhost:5001 --boats 1 | --boats beside --connect: say by --at where the area lies",
                "--connect localhost:5001 --quay 45.7,10.72 | the boats lie where they were started",
                "--connect localhost:5001 --boats 250 --at 45.7,10.72 | --boats is 1 to 249, not 250",
                "--connect localhost:5001 --boats 1 --at 45.7,10.72 --range 900 | say their range themselves",
                "--connect localhost:5001 --speed max | run at speed 1, not max",
                "--connect localhost:5001 --speed 20 | run at speed 1, not 20",
                "--connect localhost:5001 --interrupt nosuch@5 | has no interrupt 'nosuch'"
            })
    void refusesWhatMakesNoSense(String options, String said) {
        CommandResult ran = CommandResult.crw(("run clv " + options).split(" "));

        assertThat(ran.err()).contains(said);
        assertThat(ran.exitCode()).isEqualTo(ExitCode.USAGE);
        assertThat(ran.out()).isEmpty();
    }

    @Test
    void namesTheAddressesThatDoNotAnswer() throws IOException {
        int nobody;
        try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            nobody = socket.getLocalPort();
        }

        CommandResult ran =
                CommandResult.crw("run", "clv", "--connect", "127.0.0.1:" + nobody, "--connect-within", "5");

        assertThat(ran.err()).contains("not ready after 5.0 s: 127.0.0.1:" + nobody + " does not answer (");
        assertThat(ran.exitCode()).isEqualTo(ExitCode.FAILED);
    }

    @Test
    void namesTheAddressWhereSomethingElseListens() throws IOException {
        try (ServerSocket silent = new ServerSocket(0, 5, InetAddress.getLoopbackAddress())) {
            String address = "127.0.0.1:" + silent.getLocalPort();

            CommandResult ran = CommandResult.crw("run", "clv", "--connect", address, "--connect-within", "5");

            assertThat(ran.err())
                    .contains(address
                            + " does not answer (something listens there, and says nothing that a boat would say)");
            assertThat(ran.exitCode()).isEqualTo(ExitCode.FAILED);
        }
    }

    @Test
    void boatsOfARunInProcessCannotBeConnected() {
        String journal = folder.resolve("journal").toString();
        CommandResult.crw(
                "run",
                "clv",
                "--boats",
                "1",
                "--locations",
                "2",
                "--area",
                "60",
                "--speed",
                "max",
                "--for",
                "20",
                "--journal",
                journal);

        CommandResult resumed = CommandResult.crw("resume", journal, "--connect", "localhost:5001");

        assertThat(resumed.err()).contains("--connect: the boats of this run are in its own process");
        assertThat(resumed.exitCode()).isEqualTo(ExitCode.USAGE);
    }
}
