package org.sami.session.person;

import static java.util.stream.Collectors.joining;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PeopleFileTest {
    @TempDir
    private Path folder;

    @Test
    void keepsHashesOfKeysOnly() throws Exception {
        PeopleFile people = new PeopleFile(folder.resolve("people"));
        String key = PersonKey.generate();
        people.add(new Person("anna", PersonRole.PILOT, List.of("OperatorApprove"), PersonKey.hash(key)));

        assertThat(Files.readString(people.file())).doesNotContain(key);
        assertThat(people.login("anna", key)).contains(people.all().get(0));
        assertThat(people.login("anna", key + "x")).isEmpty();
        assertThat(people.all().get(0).decisions()).containsExactly("OperatorApprove");
    }

    @Test
    void sixWordsCountHoweverTheyAreTyped() throws Exception {
        PeopleFile people = new PeopleFile(folder.resolve("people"));
        String key = PersonKey.generate();
        people.add(new Person("anna", PersonRole.PILOT, List.of(), PersonKey.hash(key)));
        String[] words = key.split(" ");

        assertThat(words).hasSize(6);
        assertThat(people.login("anna", key.toUpperCase(Locale.ROOT).replace(' ', '-')))
                .isPresent();
        assertThat(people.login(
                        "anna",
                        Stream.of(words).map(word -> word.substring(0, 4)).collect(joining("."))))
                .isPresent();
        assertThat(people.login("anna", String.join(" ", List.of(words).subList(0, 5))))
                .isEmpty();
    }

    @Test
    void keyOfAnEarlierListStillCounts() throws Exception {
        PeopleFile people = new PeopleFile(folder.resolve("people"));
        String sha256OfOldKey = "762c08fc17a1cc5f00d248f8b50f2f2f4d17ff2934ac31e64deacb3f5bb3f2ec";
        people.add(new Person("anna", PersonRole.PILOT, List.of(), sha256OfOldKey));

        assertThat(people.login("anna", "old-key")).isPresent();
        assertThat(people.login("anna", "older-key")).isEmpty();
    }

    @Test
    void removedPersonIsNoLongerPresentEvenWhereTheNameComesBack() throws Exception {
        PeopleFile people = new PeopleFile(folder.resolve("people"));
        Person before = new Person("anna", PersonRole.OPERATOR, List.of(), PersonKey.hash("one"));
        people.add(before);
        people.remove("anna");
        people.add(new Person("anna", PersonRole.OPERATOR, List.of(), PersonKey.hash("two")));

        assertThat(people.present(before)).isEmpty();
        assertThatThrownBy(() -> people.add(before)).hasMessageContaining("anna is listed already");
        assertThatThrownBy(() -> people.remove("ben")).hasMessageContaining("nobody here is named 'ben'");
    }

    @Test
    void damagedListLetsNobodyIn() throws Exception {
        PeopleFile people = new PeopleFile(folder.resolve("people"));
        people.add(new Person("anna", PersonRole.OPERATOR, List.of(), PersonKey.hash("one")));
        Files.writeString(people.file(), "{");

        assertThat(people.login("anna", "one")).isEmpty();
        assertThatThrownBy(people::all).hasMessageContaining("cannot be read");
    }

    @Test
    void personOfAnotherRoleKeepsKeyAndPlaceAndIsPresentWithTheNewRights() throws Exception {
        PeopleFile people = new PeopleFile(folder.resolve("people"));
        Person before = new Person("anna", PersonRole.PILOT, List.of("OperatorApprove"), PersonKey.hash("one"));
        people.add(before);
        people.add(new Person("ben", PersonRole.OBSERVER, List.of(), PersonKey.hash("two")));

        assertThat(people.change("anna", PersonRole.OPERATOR, List.of())).isEqualTo(before);

        Person now = new Person("anna", PersonRole.OPERATOR, List.of(), before.keyHash());
        assertThat(people.present(before)).contains(now);
        assertThat(people.all().get(0)).isEqualTo(now);
        assertThatThrownBy(() -> people.change("carl", PersonRole.PILOT, List.of()))
                .hasMessageContaining("nobody here is named 'carl'");
    }

    @Test
    void damagedListSendsNobodyAwayAndLetsNobodyIn() throws Exception {
        PeopleFile people = new PeopleFile(folder.resolve("people"));
        people.add(new Person("anna", PersonRole.PILOT, List.of(), PersonKey.hash("key of anna")));
        Person anna = people.login("anna", "key of anna").orElseThrow();

        Files.writeString(people.file(), "{ damaged");

        assertThat(people.present(anna)).contains(anna);
        assertThat(people.login("anna", "key of anna")).isEmpty();
        assertThat(people.fault().orElseThrow()).contains(people.file() + " cannot be read: ");
    }
}
