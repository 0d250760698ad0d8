package org.sami.crw.cli.run;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.sami.boat.link.BoatAnnouncement;
import org.sami.boat.link.BoatAnnouncement.Access;
import org.sami.boat.link.Role;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.link.security.KeyRing;
import org.sami.boat.link.security.KeyStoreFolder;
import org.sami.boat.link.security.PairingResponder;
import org.sami.boat.link.security.PairingSecret;
import org.sami.boat.server.tcp.TcpServerConfig;
import org.sami.crw.cli.output.UsageFault;
import picocli.CommandLine.Option;

/** Who may command a boat: whoever has a key that the boat knows, or, on an open boat, whoever reaches it. */
final class BoatKeyOptions {
    @Option(
            names = "--boat-keys",
            paramLabel = "DIR",
            description = "A folder for the boat's keys, made where there is none: only bases that are paired command "
                    + "it. Without it links are plain, which a boat on another address than loopback needs --open for.")
    private @Nullable Path folder;

    @Option(
            names = "--pair",
            description = "With --boat-keys: show six words for five minutes, with which one base is paired "
                    + "(crw keys pair HOST:PORT).")
    private boolean pair;

    @Option(names = "--observer", description = "With --pair: the base may only observe, and stop the boat.")
    private boolean observer;

    @Option(names = "--open", description = "Let whoever reaches the address command the boat.")
    private boolean open;

    private Optional<PairingCodeLines> shown = Optional.empty();

    private volatile String key = "";
    private volatile BooleanSupplier pairing = () -> false;

    /** Refuses what contradicts itself, and plain links to other machines that nobody asked for. */
    void check(InetAddress bind) {
        if (folder == null && (pair || observer)) {
            throw new UsageFault("--pair and --observer need --boat-keys DIR");
        }
        if (folder == null && !open && !bind.isLoopbackAddress()) {
            throw new UsageFault("whoever reaches " + bind.getHostAddress()
                    + " could command the boat: --boat-keys DIR --pair, or --open if that is meant");
        }
        if (folder != null && open) {
            throw new UsageFault("--open and --boat-keys contradict each other");
        }
    }

    /**
     * The boat's links.
     *
     * @param say tells a person a line
     * @throws IOException if the keys cannot be read or written
     */
    UnaryOperator<TcpServerConfig> links(SteadyClock clock, Consumer<String> say) throws IOException {
        if (folder == null) {
            say.accept("links are plain: whoever reaches the port commands it");
            return UnaryOperator.identity();
        }
        KeyRing keys = new KeyStoreFolder(folder).open();
        PairingResponder responder = new PairingResponder(
                keys,
                (base, code) -> say.accept("paired with " + base.name() + "; check code " + code
                        + ": the base shows the same, or somebody is in between"));
        say.accept("its key is " + keys.identity().fingerprint().shortText() + ", it knows "
                + keys.peers().size() + (keys.peers().size() == 1 ? " base" : " bases"));
        if (pair) {
            PairingSecret words = responder.open(observer ? Role.OBSERVER : Role.COMMANDER, clock.getAsLong());
            say.accept("to pair a base within five minutes, type there: " + words);
            shown = Optional.of(new PairingCodeLines(keys.identity().fingerprint(), words));
        }
        key = keys.identity().fingerprint().shortText();
        pairing = () -> responder.isOpen(clock.getAsLong());
        return plain -> plain.withKeys(keys, responder);
    }

    /** What the boat announces of its key, and of who may command it; once its links are made. */
    BoatAnnouncement announcement(String boat, String hull) {
        Access access = folder == null ? Access.OPEN : pairing.getAsBoolean() ? Access.PAIRING : Access.PAIRED;
        return BoatAnnouncement.of(boat, key, access, hull);
    }

    /** The QR code of the pairing, now that it is known where the boat listens; empty without {@code --pair}. */
    Optional<String> qrCode(String boat, InetSocketAddress address) {
        return shown.map(lines -> lines.of(boat, address));
    }
}
