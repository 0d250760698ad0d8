package org.sami.house

/** The file THIRD-PARTY.txt of a distribution: each library in it with version, licence and home, by the list gradle/licences.txt. */
class ThirdPartyNotice {
    private static final String HEAD = '''\
        This distribution contains the libraries below, unchanged, each under its own licence. Their texts are in the libraries
        themselves where their makers put them, else at their homes, where their sources are as well.

        '''.stripIndent()

    /** {@code group:name} to licence and home. */
    private final Map<String, List<String>> known = [:]

    ThirdPartyNotice(File list) {
        list.eachLine('UTF-8') { line ->
            if (!line.isBlank() && !line.startsWith('#')) {
                def parts = line.split(/\|/)*.trim()
                known[parts[0]] = parts.drop(1)
            }
        }
    }

    /** The text for libraries, {@code group:name:version} each; a library that the list does not know is an error that names it. */
    String text(Collection<String> libraries) {
        HEAD + libraries.sort(false).collect { library ->
            def (group, name, version) = library.tokenize(':')
            def entry = known["$group:$name" as String]
            if (entry == null) {
                throw new IllegalStateException("THIRD-PARTY.txt: nothing is known of the licence of $library; enter it in gradle/licences.txt")
            }
            "$name $version\n    licence: ${entry[0]}\n    home: ${entry[1]}\n"
        }.join('')
    }
}
