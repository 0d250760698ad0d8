package org.sami.boat.app.phone;

import static org.assertj.core.api.Assertions.assertThat;

import android.net.nsd.NsdManager;
import android.net.nsd.NsdServiceInfo;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.robolectric.RobolectricTestRunner;
import org.robolectric.shadows.ShadowLooper;
import org.sami.boat.link.BoatAnnouncement;

/** What the boat announces, on a phone whose answers the test gives. */
@RunWith(RobolectricTestRunner.class)
public class PhoneAnnouncerTest {
    private static final BoatAnnouncement ANNA =
            BoatAnnouncement.of("anna", "0123456789abcdef", BoatAnnouncement.Access.PAIRED, "rudder");

    private final List<String> asked = new ArrayList<>();
    private NsdServiceInfo service = new NsdServiceInfo();
    private NsdManager.RegistrationListener listener;
    private boolean broken;

    private final PhoneAnnouncer announcer = new PhoneAnnouncer(new PhoneAnnouncer.Network() {
        @Override
        public void register(NsdServiceInfo info, NsdManager.RegistrationListener answers) {
            if (broken) {
                throw new SecurityException("no network service");
            }
            service = info;
            listener = answers;
            asked.add("register");
        }

        @Override
        public void unregister(NsdManager.RegistrationListener answers) {
            asked.add("unregister");
        }
    });

    private String entry(String key) {
        return new String(service.getAttributes().get(key), StandardCharsets.UTF_8);
    }

    private void registered() {
        listener.onServiceRegistered(service);
        ShadowLooper.idleMainLooper();
    }

    private void unregistered() {
        listener.onServiceUnregistered(service);
        ShadowLooper.idleMainLooper();
    }

    @Test
    public void announcesNamePortAndKey() {
        announcer.announce(ANNA, 11_411);

        assertThat(service.getServiceType()).isEqualTo("_sami-boat._tcp");
        assertThat(service.getServiceName()).isEqualTo("anna");
        assertThat(service.getPort()).isEqualTo(11_411);
        assertThat(entry("id")).isEqualTo("anna");
        assertThat(entry("key")).isEqualTo("0123456789abcdef");
        assertThat(entry("access")).isEqualTo("paired");
    }

    @Test
    public void sameIsAnnouncedOnceAndAChangeAnew() {
        announcer.announce(ANNA, 11_411);
        announcer.announce(ANNA, 11_411);
        registered();
        announcer.announce(ANNA.withBattery(80), 11_411);
        assertThat(asked).containsExactly("register", "unregister");
        announcer.announce(ANNA.withBattery(70), 11_411);
        unregistered();

        assertThat(asked).containsExactly("register", "unregister", "register");
        assertThat(entry("battery")).isEqualTo("70");
    }

    @Test
    public void changeThatComesBeforeTheAnswerIsNotLost() {
        announcer.announce(ANNA, 11_411);
        announcer.announce(ANNA, 12_000);
        registered();
        unregistered();

        assertThat(asked).containsExactly("register", "unregister", "register");
        assertThat(service.getPort()).isEqualTo(12_000);
    }

    @Test
    public void endTakesItBack() {
        announcer.announce(ANNA, 11_411);
        registered();
        announcer.end();
        unregistered();
        announcer.end();

        assertThat(asked).containsExactly("register", "unregister");
    }

    @Test
    public void phoneThatCannotAnnounceIsAskedAgainWhenSomethingChanges() {
        broken = true;
        announcer.announce(ANNA, 11_411);
        announcer.announce(ANNA, 11_411);
        broken = false;
        announcer.announce(ANNA, 11_411);
        assertThat(asked).isEmpty();

        announcer.announce(ANNA.withBattery(50), 11_411);
        assertThat(asked).containsExactly("register");
    }
}
