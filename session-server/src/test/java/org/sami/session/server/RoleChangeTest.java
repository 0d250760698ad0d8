package org.sami.session.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionSetup;
import org.sami.session.person.PeopleFile;
import org.sami.session.person.Person;
import org.sami.session.person.PersonKey;
import org.sami.session.person.PersonRole;
import org.sami.spn.json.DomainLibrary;

/** People whose role is changed while they are in a session. */
@Timeout(60)
class RoleChangeTest {
    private static final String START = "{\"t\":\"start\",\"id\":1,\"plan\":\"station-keep\"}";

    @TempDir
    private Path folder;

    @Test
    void frontIsToldOfAnotherRoleAndHasItsRightsFromThenOn() throws Exception {
        DomainLibrary library =
                DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
        PeopleFile people = new PeopleFile(folder.resolve("people"));
        people.add(new Person("ben", PersonRole.OBSERVER, List.of(), PersonKey.hash("key of ben")));
        try (Session session = Session.open(SessionSetup.of(
                        library.vocabulary(), library.projectOf("station-keep").orElseThrow()));
                SessionServer server = SessionServer.start(session, people, ServerAddress.onThisMachine(0))) {
            session.begin();
            TestFront ben = TestFront.loggedIn(server, "ben", "key of ben");
            ben.send(START);
            assertThat(ben.reply(1).path("text").asText()).contains("does not have the right 'start'");

            new PeopleFile(people.file()).change("ben", PersonRole.OPERATOR, List.of()); // as another process does

            assertThat(ben.until(message -> message.path("t").asText().equals("rights"))
                            .path("role")
                            .asText())
                    .isEqualTo("operator");
            ben.send(START.replace("1", "2"));
            assertThat(ben.reply(2).path("t").asText()).isEqualTo("done");
        }
    }
}
