package org.sami.crw.gui;

import java.net.InetAddress;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import org.sami.boat.link.security.Identity;
import org.sami.boat.server.testing.Await;
import org.sami.crw.proxy.key.BaseKeys;
import org.sami.session.person.PersonRole;
import org.sami.session.server.ServerAddress;
import org.sami.session.server.SessionBases;
import org.sami.session.server.SessionServer;
import org.sami.session.server.testing.ServedSession;

/** A base in a process of its own that serves a session by HTTPS, in which a mission asks; it says when it is answered and when the fleet is stopped. */
final class LossyBase {
    private static final double WITHIN_S = 900;

    private LossyBase() {}

    /**
     * Serves it until it is killed.
     *
     * @param args the folder of the base's files, and the address at which it listens
     */
    public static void main(String[] args) throws Exception {
        Path folder = Path.of(args[0]);
        Identity identity = new BaseKeys(folder.resolve("keys")).open().identity();
        ServedSession served =
                ServedSession.ofProject(RemoteWindowTest.PROJECT, folder).with("anna", PersonRole.OPERATOR);
        SessionServer server = served.serve(
                new ServerAddress(InetAddress.getByName(args[1]), 0, Optional.of(identity)), SessionBases.NONE);
        served.begin();
        served.session().start("talk", "talk", Map.of()).toCompletableFuture().get();
        System.out.println(
                "wss://" + args[1] + ":" + server.listensAt().getPort() + " " + ServerAddress.print(identity));

        Await.until(
                "it is answered",
                WITHIN_S,
                () -> served.session().models().missions().snapshot().missions().stream()
                        .allMatch(mission -> mission.hasEnded()));
        System.out.println("answered");
        Await.until(
                "the fleet is stopped",
                WITHIN_S,
                () -> served.session().models().fleetStop().snapshot().everyBoat());
        System.out.println("stopped");
    }
}
