package org.sami.crw.gui.station;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.DatagramSocket;
import java.net.InetAddress;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.cli.station.StationLinks;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.sim.boat.SimulatedBoatsOnTcp;
import org.sami.mavlink.address.AddressText;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/** What Alt+Shift+G says of an address, and whom a ground station sees. */
@Timeout(900)
class StationFormTest {
    private static final String SAID = "ground-station-said";

    private static void until(StationForm form, String words) {
        SessionWorld.until("\"" + words + "\" is said", () -> {
            form.refresh();
            return SessionWorld.text(form, SAID).contains(words);
        });
    }

    private static long seen(MavlinkBase station) {
        return station.vehicles().join().stream()
                .filter(VehicleSnapshot::located)
                .count();
    }

    @Test
    void aStationSeesEachSimulatedBoatAsAVehicleOfItsOwn() throws Exception {
        int port;
        try (DatagramSocket free = new DatagramSocket(0, InetAddress.getLoopbackAddress())) {
            port = free.getLocalPort();
        }
        try (SessionWorld world = new SessionWorld(SessionWorld.library("clv"));
                SimulatedBoatsOnTcp boats = new SimulatedBoatsOnTcp(1)) {
            boats.launch("anna", SessionWorld.PIER);
            StationLinks show = new StationLinks(boats);
            StationForm form = SessionWorld.laidOut(() -> new StationForm(world.context, show));
            assertThat(SessionWorld.text(form, "ground-station-address")).isEqualTo(StationLinks.USUAL);

            SessionWorld.type(form, "ground-station-address", "udp:127.0.0.1:" + port);
            SessionWorld.press(form, "ground-station-do");
            until(form, "anna, as vehicle 1, is shown at udp:127.0.0.1:" + port + ". No ground station has answered");

            boats.launch("bert", SessionWorld.PIER); // also those that are added later
            try (MavlinkBase station =
                    new MavlinkBase(List.of(AddressText.parse("mavlink:udp:" + port)), ProcessClock::ms)) {
                SessionWorld.until("both are seen", () -> seen(station) == 2);
                until(form, "2 boats, anna to bert as vehicles 1 to 2, are shown");
                until(form, "A ground station answers.");

                SessionWorld.press(form, "ground-station-stop");
                assertThat(SessionWorld.text(form, SAID)).isEmpty();
                assertThat(show.where()).isEmpty();
            }
        }
    }

    @Test
    void anAddressThatCannotBeIsSaidWithWhatToDo() throws Exception {
        try (SessionWorld world = new SessionWorld(SessionWorld.library("clv"));
                SimulatedBoatsOnTcp boats = new SimulatedBoatsOnTcp(1)) {
            StationLinks show = new StationLinks(boats);
            StationForm form = SessionWorld.laidOut(() -> new StationForm(world.context, show));

            SessionWorld.type(form, "ground-station-address", "udp:127.0.0.1:0");
            SessionWorld.press(form, "ground-station-do");
            assertThat(SessionWorld.text(form, SAID)).contains("▲").contains("a port is 1 to 65535");
            SessionWorld.type(form, "ground-station-address", "serial:/dev/ttyUSB0:57600");
            SessionWorld.press(form, "ground-station-do");
            assertThat(SessionWorld.text(form, SAID)).contains("a serial port is for one boat: crw boat --mavlink");
            SessionWorld.type(form, "ground-station-address", "");
            SessionWorld.press(form, "ground-station-do");
            assertThat(SessionWorld.text(form, SAID)).contains("Type the address, such as udp:127.0.0.1:14550");
            assertThat(show.where()).isEmpty();
        }
    }
}
