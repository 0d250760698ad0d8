package org.sami.session.person;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.security.SecureRandom;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PeopleFileTest {
    @TempDir
    private Path folder;

    @Test
    void keepsHashesOfKeysOnly() throws Exception {
        PeopleFile people = new PeopleFile(folder.resolve("people"));
        String key = PersonKey.generate(new SecureRandom());
        people.add(new Person("anna", PersonRole.PILOT, List.of("OperatorApprove"), PersonKey.hash(key)));

        assertThat(Files.readString(people.file())).doesNotContain(key);
        assertThat(people.login("anna", key)).contains(people.all().get(0));
        assertThat(people.login("anna", key + "x")).isEmpty();
        assertThat(people.all().get(0).decisions()).containsExactly("OperatorApprove");
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
}
