package org.sami.crw.cli.key;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.PrintWriter;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.Callable;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.sami.boat.link.Role;
import org.sami.boat.link.SteadyClock;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.StopOnInterrupt;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.proxy.key.BaseKeys;
import org.sami.crw.proxy.phone.ApkFile;
import org.sami.crw.proxy.phone.OwnNetwork;
import org.sami.crw.proxy.phone.PhoneOffer;
import picocli.CommandLine.Command;
import picocli.CommandLine.Help.Ansi;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code crw phone}: the app and the pairing for phones on the same network, while the code is shown. */
@Command(
        name = "phone",
        mixinStandardHelpOptions = true,
        description = "Shows a QR code with which a phone on the same network fetches the app and is paired with this "
                + "base. Phone after phone, until Ctrl-C; nothing is served afterwards.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:done (--once)",
            "2:wrong usage, a file that is no APK of the app, or several networks to choose from",
            "4:nothing can be served there, or the phone was not paired (--once)",
            "130:stopped by Ctrl-C",
            "143:stopped by a signal"
        },
        footerHeading = "%nExamples:%n",
        footer = {
            "  crw phone                           the app that ./gradlew apk has made",
            "  crw phone --address 192.168.43.2 --apk sami-boat.apk --once"
        })
public final class PhoneCommand implements Callable<Integer> {
    private static final long LOOK_MS = 1000;

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    private KeyFolderOption keys = new KeyFolderOption();

    @Option(
            names = "--address",
            paramLabel = "HOST",
            description =
                    "The address of this computer in the phones' network; not needed where it is in one network only.")
    private @Nullable String address;

    @Option(
            names = "--apk",
            paramLabel = "FILE",
            description = "The app; without it, the one that ./gradlew apk has made in the project around here.")
    private @Nullable Path apk;

    @Option(names = "--observer", description = "Phones let this base only observe, and stop the boat.")
    private boolean observer;

    @Option(names = "--once", description = "End after the first phone.")
    private boolean once;

    private final InputStream input;
    private final BlockingQueue<Event> events = new LinkedBlockingQueue<>();

    /** Answers come from the standard input. */
    public PhoneCommand() {
        this(System.in);
    }

    /** Answers come from there. */
    PhoneCommand(InputStream input) {
        this.input = input;
    }

    /** What happens while the code is shown. */
    private sealed interface Event {
        /** A phone has proved itself. */
        record Proved(PhoneOffer.Phone phone) implements Event {}

        /** Something was refused. */
        record Refused(String why) implements Event {}

        /** The person has typed a line; empty at the end of the input. */
        record Typed(Optional<String> line) implements Event {}
    }

    @Override
    public Integer call() throws IOException {
        InetAddress at = address();
        Optional<ApkFile> app = app();
        PhoneOffer.Setup setup = UsageFault.of(() ->
                new PhoneOffer.Setup(at, app, BaseKeys.nameOfThisBase(), observer ? Role.OBSERVER : Role.COMMANDER));
        try (StopOnInterrupt stop = new StopOnInterrupt();
                PhoneOffer offer = new PhoneOffer(
                        setup, keys.keys().open(), SteadyClock.ofThisMachine(), new PhoneOffer.Listener() {
                            @Override
                            public void proved(PhoneOffer.Phone phone) {
                                events.add(new Event.Proved(phone));
                            }

                            @Override
                            public void refused(String why) {
                                events.add(new Event.Refused(why));
                            }
                        })) {
            say(app.map(file -> "app: " + file.path() + ", " + file.size() + ", SHA-256 " + file.sha256())
                    .orElse("no app to give: " + ApkFile.HOW_TO_MAKE
                            + " (--apk FILE). Phones that have it are paired"));
            readInput();
            return show(offer);
        } catch (InterruptedException stopped) {
            say("nothing is served any more");
            return ExitCode.OK;
        }
    }

    private InetAddress address() throws IOException {
        if (address != null) {
            try {
                return InetAddress.getByName(address);
            } catch (UnknownHostException e) {
                throw new UsageFault("--address: there is no host " + address);
            }
        }
        List<OwnNetwork> networks = OwnNetwork.all();
        if (networks.isEmpty()) {
            throw new UsageFault("this computer is in no network: join that of the phones");
        }
        if (networks.size() > 1) {
            throw new UsageFault("which network are the phones in? --address with one of "
                    + String.join(
                            ", ", networks.stream().map(OwnNetwork::toString).toList()));
        }
        return networks.get(0).address();
    }

    private Optional<ApkFile> app() throws IOException {
        if (apk != null) {
            return Optional.of(readApk(apk));
        }
        Optional<Path> found = ApkFile.find();
        return found.isPresent() ? Optional.of(readApk(found.get())) : Optional.empty();
    }

    private static ApkFile readApk(Path file) {
        try {
            return ApkFile.read(file);
        } catch (IOException e) {
            throw new UsageFault(String.valueOf(e.getMessage()));
        }
    }

    private void readInput() {
        Thread reader = new Thread(
                () -> {
                    try {
                        BufferedReader lines = new BufferedReader(new InputStreamReader(input, StandardCharsets.UTF_8));
                        for (String line = lines.readLine(); line != null; line = lines.readLine()) {
                            events.add(new Event.Typed(Optional.of(line.strip())));
                        }
                    } catch (IOException gone) {
                        // as at its end
                    }
                    events.add(new Event.Typed(Optional.empty()));
                },
                "answers");
        reader.setDaemon(true);
        reader.start();
    }

    private int show(PhoneOffer offer) throws InterruptedException {
        String shown = "";
        boolean inputEnded = false;
        boolean asked = false; // a line typed before the check code is shown answers nothing
        while (true) {
            Optional<PhoneOffer.Phone> waiting = offer.waiting();
            if (waiting.isEmpty() && !shown.equals(offer.code())) {
                shown = offer.code();
                showCode(shown);
            }
            Optional<Event> next = Optional.ofNullable(events.poll(LOOK_MS, TimeUnit.MILLISECONDS));
            Optional<Boolean> same = Optional.empty();
            if (next.orElse(null) instanceof Event.Refused refused) {
                say(refused.why());
            } else if (next.orElse(null) instanceof Event.Proved proved) {
                asked = true;
                say(proved.phone().boat().name() + " shows the check code "
                        + proved.phone().checkCode() + "? y: yes, pair it; n: no, somebody may be in between");
                same = inputEnded ? Optional.of(false) : Optional.empty();
            } else if (next.orElse(null) instanceof Event.Typed typed) {
                inputEnded |= typed.line().isEmpty();
                if (asked) {
                    same = typed.line().isEmpty()
                            ? Optional.of(false)
                            : answer(typed.line().get());
                }
            }
            if (same.isPresent()) {
                asked = false;
                boolean paired = end(offer, same.get());
                if (once) {
                    return paired ? ExitCode.OK : ExitCode.FAILED;
                }
            }
        }
    }

    private Optional<Boolean> answer(String line) {
        if (line.equalsIgnoreCase("y") || line.equalsIgnoreCase("n")) {
            return Optional.of(line.equalsIgnoreCase("y"));
        }
        say("y or n?");
        return Optional.empty();
    }

    /** Whether the phone that waited is paired now. */
    private boolean end(PhoneOffer offer, boolean same) {
        String name = offer.waiting().map(phone -> phone.boat().name()).orElse("the phone");
        try {
            if (same) {
                offer.confirm();
                say("paired with " + name + "; say yes on the phone, too");
                return true;
            }
            say(name + " is not paired: nothing is kept here. Say no on the phone, too");
        } catch (IOException e) {
            say(name + " is not paired: its key cannot be kept: " + e.getMessage());
        }
        offer.deny();
        return false;
    }

    private void showCode(String code) {
        PrintWriter out = spec.commandLine().getOut();
        out.print(QrCode.of(code).halfBlocks(Ansi.AUTO.enabled()));
        out.println(code);
        out.println("Scan it with the phone's camera, on a network of your own. Ctrl-C ends it.");
        out.flush();
    }

    private void say(String text) {
        PrintWriter err = spec.commandLine().getErr();
        err.println(text);
        err.flush();
    }
}
