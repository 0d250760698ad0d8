package org.sami.crw.cli.key;

import java.io.IOException;
import java.io.PrintWriter;
import java.net.InetAddress;
import java.util.Scanner;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sami.boat.link.security.WordSecret;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.proxy.tcp.BoatPairing;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw keys pair}. */
@Command(
        name = "pair",
        mixinStandardHelpOptions = true,
        description = "Pairs the boat at an address, which shows six words (crw boat --pair).")
final class PairCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    private KeyFolderOption keys = new KeyFolderOption();

    @Parameters(paramLabel = "HOST:PORT", description = "Where the boat's server listens.")
    private String text = "";

    @Option(
            names = "--words",
            paramLabel = "WORDS",
            description = "The six words, or the text of the QR code, in quotes; asked for if they are not given.")
    private @Nullable String words;

    @Override
    public Integer call() throws IOException {
        PrintWriter out = spec.commandLine().getOut();
        BoatPairing.Result result =
                BoatPairing.pair(address(), secret(), name(), keys.folder().open());
        out.println("paired with " + result.boat().name() + ", key "
                + result.boat().fingerprint().shortText());
        out.println("check code " + result.checkCode()
                + ": the boat shows the same, or somebody is in between (crw keys withdraw "
                + result.boat().name() + ")");
        return ExitCode.OK;
    }

    private java.net.InetSocketAddress address() {
        try {
            return BoatAddress.parse(text).toSocketAddress();
        } catch (IllegalArgumentException e) {
            throw new UsageFault(String.valueOf(e.getMessage()));
        }
    }

    private WordSecret secret() {
        String typed = words;
        if (typed == null) {
            spec.commandLine().getErr().print("The six words that the boat shows: ");
            spec.commandLine().getErr().flush();
            Scanner input = new Scanner(System.in, java.nio.charset.StandardCharsets.UTF_8);
            typed = input.hasNextLine() ? input.nextLine() : "";
        }
        try {
            return WordSecret.parse(typed);
        } catch (IllegalArgumentException e) {
            throw new UsageFault(String.valueOf(e.getMessage()));
        }
    }

    private static String name() throws IOException {
        return System.getProperty("user.name") + " at "
                + InetAddress.getLocalHost().getHostName();
    }
}
