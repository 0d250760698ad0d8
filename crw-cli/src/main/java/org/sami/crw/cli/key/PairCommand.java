package org.sami.crw.cli.key;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.util.Scanner;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sami.boat.link.Role;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.proxy.key.BaseKeys;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.proxy.tcp.BoatPairing;
import org.sami.crw.proxy.tcp.PairingText;
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

    @Parameters(
            paramLabel = "HOST:PORT",
            arity = "0..1",
            description = "Where the boat's server listens; not needed where the text of the QR code says it.")
    private @Nullable String text;

    @Option(
            names = "--words",
            paramLabel = "WORDS",
            description = "The six words, or the text of the QR code, in quotes; asked for if they are not given.")
    private @Nullable String words;

    @Option(names = "--observer", description = "Pair this base so that it may only observe, and stop the boat.")
    private boolean observer;

    @Override
    public Integer call() throws IOException {
        PrintWriter out = spec.commandLine().getOut();
        String typed = words == null ? ask() : words;
        PairingText told = UsageFault.of(() -> PairingText.parse(typed));
        BoatAddress address = UsageFault.of(() -> told.address(text == null ? "" : text));
        BoatPairing pairing = new BoatPairing(
                new BoatPairing.Request(
                        address.toSocketAddress(),
                        told.words(),
                        told.key(),
                        observer ? Role.OBSERVER : Role.COMMANDER,
                        BaseKeys.nameOfThisBase()),
                keys.keys().open());
        BoatPairing.Result result = pairing.prove();
        pairing.keep(result);
        out.println("paired with " + result.boat().name() + ", key "
                + result.boat().fingerprint().shortText()
                + (result.boat().role() == Role.OBSERVER ? ", as an observer" : ""));
        out.println("check code " + result.checkCode()
                + ": the boat shows the same, or somebody is in between (crw keys withdraw "
                + result.boat().name() + ")");
        return ExitCode.OK;
    }

    private String ask() {
        spec.commandLine().getErr().print("The six words that the boat shows: ");
        spec.commandLine().getErr().flush();
        Scanner input = new Scanner(System.in, StandardCharsets.UTF_8);
        return input.hasNextLine() ? input.nextLine() : "";
    }
}
