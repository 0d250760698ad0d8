package org.sami.crw.cli.vehicle;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.time.Instant;
import java.time.ZoneId;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.sami.boat.link.SteadyClock;
import org.sami.crw.cli.option.SecondsConverter;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.StopOnInterrupt;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.proxy.key.BaseKeys;
import org.sami.crw.proxy.tcp.BaseProtection;
import org.sami.mavlink.address.AddressText;
import org.sami.mavlink.address.MavlinkAddress;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.base.MavlinkBaseOptions;
import org.sami.mavlink.base.MessagePlan;
import org.sami.mavlink.link.LinkSigning;
import org.sami.mavlink.link.MavlinkLinkReport;
import org.sami.mavlink.link.SigningKey;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.param.KeptParameters;
import org.sami.mavlink.param.ParameterFiles;
import org.sami.mavlink.vehicle.VehicleSnapshot;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code crw vehicles}: which vehicles speak MAVLink on some links, how they are, and what they hold. It moves none. */
@Command(
        name = "vehicles",
        mixinStandardHelpOptions = true,
        description =
                "Lists the vehicles of other makers (ArduPilot boats, copters) that speak MAVLink at these addresses:"
                        + " mode, position, battery, GPS, and how well each link hears them. Moves nothing and sets no parameter; asks"
                        + " vehicles for the messages that it reads, which on a slow radio takes unasked streams from"
                        + " other ground stations on that radio.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:every link brought a vehicle, also one that is not commanded from here",
            "2:wrong usage",
            "4:a link brought no vehicle, or a list could not be read",
            "130:stopped by Ctrl-C"
        },
        footerHeading = "%nExamples:%n",
        footer = {
            "  crw vehicles mavlink:tcp:127.0.0.1:5760             a simulated ArduPilot boat",
            "  crw vehicles mavlink:udp:14550                      who sends to this machine's usual port",
            "  crw vehicles mavlink:serial:/dev/ttyUSB0:57600      a telemetry radio",
            "  crw vehicles --budget-for 25 mavlink:serial:/dev/ttyUSB0:57600   what 25 vehicles would be asked for",
            "  crw vehicles --held mavlink:tcp:127.0.0.1:5760      with the mission, fence and rally points that they"
                    + " hold"
        })
public final class VehiclesCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Parameters(paramLabel = "ADDRESS", arity = "1..*", description = "A link: " + MavlinkAddress.FORMS + ".")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private List<String> texts;

    @Option(
            names = "--for",
            paramLabel = "SECONDS",
            defaultValue = "5",
            converter = SecondsConverter.class,
            description = "How long to listen (default ${DEFAULT-VALUE}).")
    private long listenMillis;

    @Option(names = "--held", description = "Also read the missions, fences and rally points that the vehicles hold.")
    private boolean held;

    @Option(
            names = "--budget",
            description =
                    "Also print what the vehicles on each link are asked to send, and which part of a slow link it"
                            + " fills.")
    private boolean budget;

    @Option(
            names = "--budget-for",
            paramLabel = "N",
            defaultValue = "0",
            description = "Only compute that for N vehicles on each link; opens nothing.")
    private int budgetFor;

    @Option(
            names = "--parameters",
            paramLabel = "DIR",
            description =
                    "Also read all parameters of each vehicle, print which have changed since they were kept last,"
                            + " and keep them in a file of this folder.")
    private @Nullable Path parameters;

    @Option(
            names = "--signed",
            description =
                    "Sign with the key of this fleet (crw keys fleet), and refuse vehicles that do not sign with it.")
    private boolean signed;

    @Option(
            names = "--keys",
            paramLabel = "DIR",
            description = "With --signed: the folder of the keys (default: ~/.config/sami/keys).")
    private @Nullable Path keys;

    @Override
    public Integer call() throws InterruptedException, IOException {
        List<MavlinkAddress> addresses = addresses();
        if (budgetFor > 0) {
            addresses.forEach(address -> spec.commandLine()
                    .getOut()
                    .print(BudgetText.of(address, MessagePlan.of(address, budgetFor, signed))));
            spec.commandLine().getOut().flush();
            return ExitCode.OK;
        }
        MavlinkBaseOptions options =
                new MavlinkBaseOptions(Optional.ofNullable(parameters).map(ParameterFiles::new), signing());
        SteadyClock clock = SteadyClock.ofThisMachine();
        PrintWriter out = spec.commandLine().getOut();
        try (StopOnInterrupt stop = new StopOnInterrupt();
                MavlinkBase base = new MavlinkBase(addresses, clock, options)) {
            listen();
            List<VehicleSnapshot> vehicles = base.vehicles().join();
            List<MavlinkLinkReport> links = base.links();
            VehicleText text = new VehicleText(clock.getAsLong());
            out.print(text.table(vehicles));
            out.print(VehicleText.notCommanded(vehicles));
            out.print(text.links(links, vehicles));
            out.print(VehicleText.ways(vehicles));
            out.print(text.said(vehicles));
            out.print(VehicleText.faults(vehicles));
            if (budget) {
                base.plans().join().forEach((link, plan) -> out.print(BudgetText.of(link, plan)));
            }
            boolean whole = !held || printHeld(base, vehicles, out);
            if (parameters != null) {
                whole &= keepParameters(base, vehicles, parameters, out);
            }
            out.flush();
            return whole && links.stream().allMatch(link -> VehicleText.isHeard(link, vehicles))
                    ? ExitCode.OK
                    : ExitCode.FAILED;
        }
    }

    private Optional<LinkSigning> signing() throws IOException {
        if (!signed) {
            return Optional.empty();
        }
        Path folder = keys == null ? BaseProtection.folderOfThisUser() : keys;
        byte[] secret = new BaseKeys(folder)
                .fleetKey()
                .orElseThrow(() -> new UsageFault(folder + " has no key of a fleet: crw keys fleet makes one"));
        return Optional.of(new LinkSigning(new SigningKey(secret), Instant::now, LinkSigning.Unsigned.REFUSED));
    }

    private boolean keepParameters(MavlinkBase base, List<VehicleSnapshot> vehicles, Path folder, PrintWriter out) {
        boolean whole = true;
        for (VehicleSnapshot vehicle : vehicles) {
            try {
                Optional<KeptParameters> before = new ParameterFiles(folder).load(vehicle.id());
                SortedMap<String, Double> values =
                        base.readParameters(vehicle.id()).join();
                out.print(ParameterText.of(vehicle.id(), values, before, folder, ZoneId.systemDefault()));
            } catch (CompletionException e) {
                Throwable cause = e.getCause();
                err(cause == null ? e.toString() : String.valueOf(cause.getMessage()));
                whole = false;
            }
        }
        return whole;
    }

    private void listen() throws InterruptedException {
        new CountDownLatch(1).await(listenMillis, TimeUnit.MILLISECONDS); // vehicles speak by themselves
    }

    private boolean printHeld(MavlinkBase base, List<VehicleSnapshot> vehicles, PrintWriter out) {
        boolean whole = true;
        for (VehicleSnapshot vehicle : vehicles) {
            for (HeldKind kind : HeldKind.values()) {
                try {
                    out.print(VehicleText.held(
                            vehicle, kind, base.held(vehicle.id(), kind).join()));
                } catch (CompletionException e) {
                    Throwable cause = e.getCause();
                    err(cause == null ? e.toString() : String.valueOf(cause.getMessage()));
                    whole = false;
                }
            }
        }
        return whole;
    }

    private void err(String what) {
        PrintWriter err = spec.commandLine().getErr();
        err.println("crw: " + what);
        err.flush();
    }

    private List<MavlinkAddress> addresses() {
        try {
            return texts.stream()
                    .flatMap(text -> List.of(text.split(",")).stream())
                    .map(AddressText::parse)
                    .toList();
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), e.getMessage());
        }
    }
}
