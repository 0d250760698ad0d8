package org.sami.crw.cli.key;

import java.io.IOException;
import java.io.PrintWriter;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.sami.boat.link.SteadyClock;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.UsageFault;
import org.sami.mavlink.address.AddressText;
import org.sami.mavlink.address.MavlinkAddress;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.base.MavlinkBaseOptions;
import org.sami.mavlink.link.LinkSigning;
import org.sami.mavlink.link.SigningKey;
import org.sami.mavlink.vehicle.VehicleSnapshot;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code crw keys fleet}: the key with which vehicles of other makers sign, and giving it to them. */
@Command(
        name = "fleet",
        mixinStandardHelpOptions = true,
        description =
                "The key with which the vehicles of other makers in this base's fleet sign (MAVLink 2 signing): made"
                        + " where there is none, and shown by its fingerprint. crw keys export and import take it along.")
final class FleetKeyCommand implements Callable<Integer> {
    private static final int LISTEN_S = 5;

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    private KeyFolderOption keys = new KeyFolderOption();

    @Option(
            names = "--give",
            paramLabel = "ADDRESS",
            description = "Give the key to all vehicles there: over a cable, as the key is sent in the open. Only"
                    + " mavlink:serial:DEVICE:BAUD is taken, and mavlink:tcp of this machine, as a simulator has it.")
    private List<String> give = new ArrayList<>();

    @Option(
            names = "--over-network",
            description =
                    "Give it over a network too, to mavlink:tcp or mavlink:udpout of another machine: only where you"
                            + " know that nobody else is on that network. Who reads along commands the fleet.")
    private boolean overNetwork;

    @Option(
            names = "--new",
            description =
                    "Make another key in place of the present one, as where a laptop that has it was lost. Vehicles"
                            + " obey the old key until they are given the new one, over the cable of their first port.")
    private boolean renewed;

    @Override
    public Integer call() throws IOException, InterruptedException {
        List<MavlinkAddress> addresses =
                UsageFault.of(() -> give.stream().map(AddressText::parse).toList());
        KeyLinks.check(addresses, overNetwork);
        SigningKey key = new SigningKey(
                renewed ? keys.keys().renewFleetKey() : keys.keys().makeFleetKey());
        PrintWriter out = spec.commandLine().getOut();
        out.println(key.fingerprint() + "  this fleet");
        out.flush();
        return addresses.isEmpty() ? ExitCode.OK : give(addresses, key, out);
    }

    private int give(List<MavlinkAddress> addresses, SigningKey key, PrintWriter out) throws InterruptedException {
        LinkSigning signing = new LinkSigning(key, Instant::now, LinkSigning.Unsigned.TAKEN);
        try (MavlinkBase base = new MavlinkBase(
                addresses,
                SteadyClock.ofThisMachine(),
                new MavlinkBaseOptions(Optional.empty(), Optional.of(signing)))) {
            new CountDownLatch(1).await(LISTEN_S, TimeUnit.SECONDS); // vehicles speak by themselves
            List<VehicleSnapshot> vehicles = base.vehicles().join();
            boolean all = !vehicles.isEmpty();
            if (!all) {
                out.println("no vehicle was heard");
            }
            for (VehicleSnapshot vehicle : vehicles) {
                all &= give(base, vehicle, out);
            }
            out.flush();
            return all ? ExitCode.OK : ExitCode.FAILED;
        }
    }

    private static boolean give(MavlinkBase base, VehicleSnapshot vehicle, PrintWriter out) {
        try {
            base.giveKey(vehicle.id()).join();
            out.println("vehicle " + vehicle.id() + " signs with it");
            return true;
        } catch (CompletionException e) {
            Throwable cause = e.getCause();
            out.println(cause == null ? e.toString() : String.valueOf(cause.getMessage()));
            return false;
        }
    }
}
